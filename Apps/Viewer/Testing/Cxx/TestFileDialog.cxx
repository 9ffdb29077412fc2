// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The dialog of files: mouse, keys, filters, paths, names that exist.
#include "heliosFileDialog.h"
#include "heliosPainter.h"
#include "heliosViewerInputs.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;
using namespace helios::viewer;
using Catch::Matchers::Contains;

namespace
{

constexpr int Size = 12;            // text size
const Rect Place{ 0, 0, 600, 400 }; // place of the dialog

/// A folder with a subfolder, two surveys, a cloud, a run and files of no use here.
struct Folder
{
  Folder()
  {
    std::string name = (fs::temp_directory_path() / "vtkHeliosFilesXXXXXX").string();
    this->Path = fs::canonical(::mkdtemp(name.data()));
    fs::create_directories(this->Path / "sub" / "deep");
    fs::create_directories(this->Path / "my_run");
    this->Write("my_run/run_summary.json", "{}");
    this->Write("a.xml", "<document><survey/></document>");
    this->Write("B.xml", "<document><scene/></document>");
    this->Write("yard.las", "");
    this->Write("notes.odt", "");
    this->Write(".hidden.xml", "<document><survey/></document>");
    this->Write("state.json", "{ \"type\": \"State\" }");
    this->Write("sub/inner.xyz", "1 2 3\n");
  }
  ~Folder() { fs::remove_all(this->Path); }

  void Write(const std::string& name, const std::string& text) const
  {
    std::ofstream(this->Path / name) << text;
  }

  fs::path Path;
};

struct OpenDialog : Folder
{
  OpenDialog()
  {
    this->Dialog.Open((this->Path / "none").string(), FindInputKind,
      [this](const std::string& path)
      {
        this->Opened.push_back(path);
        return this->Problem.empty() ? helios::Status() : helios::Status::Error(this->Problem);
      });
  }

  std::vector<std::string> GetNames() const
  {
    std::vector<std::string> names;
    for (const FileEntry& entry : this->Dialog.GetList().GetEntries())
    {
      names.push_back(entry.Name);
    }
    return names;
  }

  void Type(const std::string& text)
  {
    for (const char c : text)
    {
      this->Dialog.OnKey(std::string(1, c), c);
    }
  }

  void Press(const Rect& rect, double time)
  {
    this->Dialog.OnPress(Place, rect.X + 5, rect.Y + rect.Height / 2, Size, time);
  }

  FileDialog Dialog;
  std::vector<std::string> Opened;
  std::string Problem;
};

using Names = std::vector<std::string>;

} // namespace

TEST_CASE("FileDialog: it lists folders first, and what can be opened")
{
  OpenDialog test;
  CHECK(test.GetNames() == Names{ "my_run", "sub", "a.xml", "B.xml", "yard.las" });
  const auto& entries = test.Dialog.GetList().GetEntries();
  CHECK(entries[0].Kind == "run");
  CHECK(entries[1].Kind.empty());
  CHECK(entries[2].Kind == "survey");
  CHECK(entries[3].Kind == "scene");
  CHECK(entries[4].Kind == "points");
  CHECK(test.Dialog.GetSize(Size).Width > 0);
  test.Dialog.OnKey("Escape", 27);
  CHECK_FALSE(test.Dialog.IsOpen());
  CHECK(test.Dialog.GetSize(Size).IsEmpty());
  CHECK(test.Opened.empty());
  test.Write("city.json", "{ \"type\": \"CityJSON\" }");
  CHECK(FindInputKind((test.Path / "city.json").string()) == "scene");
}

TEST_CASE("FileDialog: letters filter, Return opens a file or enters a folder")
{
  OpenDialog test;
  test.Type("XML");
  CHECK(test.GetNames() == Names{ "a.xml", "B.xml" });
  test.Dialog.OnKey("Down", 0);
  test.Dialog.OnKey("Return", '\r');
  CHECK(test.Opened == Names{ (test.Path / "B.xml").string() });
  CHECK_FALSE(test.Dialog.IsOpen());

  OpenDialog other;
  other.Type("su");
  other.Dialog.OnKey("Return", '\r');
  CHECK(other.Dialog.GetList().GetFolder() == (other.Path / "sub").string());
  CHECK(other.GetNames() == Names{ "deep", "inner.xyz" });
  other.Dialog.OnKey("BackSpace", '\b'); // without a text it goes up
  CHECK(other.Dialog.GetList().GetFolder() == other.Path.string());
  CHECK(other.Dialog.GetList().GetEntry()->Name == "sub");
  other.Type("zzz");
  other.Dialog.OnKey("Return", '\r');
  CHECK(other.Dialog.GetHint() == "no name here contains \"zzz\"");
  other.Dialog.OnKey("BackSpace", '\b');
  CHECK(other.Dialog.GetText() == "zz");
  CHECK(other.Dialog.GetHint().empty());
  CHECK(other.Opened.empty());
}

TEST_CASE("FileDialog: a run is a folder that is opened, or entered by Right")
{
  OpenDialog test;
  CHECK(test.Dialog.GetList().GetEntry()->Name == "my_run");
  test.Dialog.OnKey("Right", 0);
  CHECK(test.Dialog.GetList().GetFolder() == (test.Path / "my_run").string());
  test.Dialog.OnKey("Return", '\r');
  CHECK(test.Dialog.GetHint() == "nothing here can be opened");
  test.Dialog.OnKey("Left", 0);
  test.Dialog.OnKey("Return", '\r');
  CHECK(test.Opened == Names{ (test.Path / "my_run").string() });
}

TEST_CASE("FileDialog: paths are completed and opened")
{
  OpenDialog test;
  test.Type(test.Path.string() + "/su");
  CHECK(test.GetNames().size() == 5); // no filter
  test.Dialog.OnKey("Tab", '\t');
  CHECK(test.Dialog.GetText() == test.Path.string() + "/sub/");
  test.Type("i");
  test.Dialog.OnKey("Tab", '\t');
  test.Dialog.OnKey("Return", '\r');
  CHECK(test.Opened == Names{ (test.Path / "sub" / "inner.xyz").string() });

  OpenDialog other;
  other.Type("sub/none.las");
  other.Dialog.OnKey("Return", '\r');
  CHECK(other.Dialog.GetHint() ==
    (other.Path / "sub/none.las").string() + ": no such file; check the name");
  CHECK(other.Dialog.IsOpen());
}

TEST_CASE("FileDialog: an error of the file is told, and the dialog stays")
{
  OpenDialog test;
  test.Problem = "a.xml:1: has no legs";
  test.Type("a.xml");
  test.Dialog.OnKey("Return", '\r');
  CHECK(test.Dialog.IsOpen());
  CHECK(test.Dialog.GetHint() == test.Problem);
}

TEST_CASE("FileDialog: a click selects, a double click opens, buttons do what they say")
{
  OpenDialog test;
  test.Press(test.Dialog.GetRow(Place, 4, Size), 1.0);
  CHECK(test.Dialog.GetList().GetEntry()->Name == "yard.las");
  test.Press(test.Dialog.GetRow(Place, 4, Size), 3.0); // too late for a double click
  CHECK(test.Opened.empty());
  test.Press(test.Dialog.GetRow(Place, 1, Size), 4.0);
  test.Press(test.Dialog.GetRow(Place, 1, Size), 4.2);
  CHECK(test.Dialog.GetList().GetFolder() == (test.Path / "sub").string());
  const FileDialog::Places places = FileDialog::GetPlaces(Place, Size);
  test.Press(places.Up, 5.0);
  CHECK(test.Dialog.GetList().GetFolder() == test.Path.string());
  test.Press(test.Dialog.GetRow(Place, 2, Size), 6.0);
  test.Press(places.Accept, 6.1);
  CHECK(test.Opened == Names{ (test.Path / "a.xml").string() });
  OpenDialog other;
  other.Press(places.Cancel, 1.0);
  CHECK_FALSE(other.Dialog.IsOpen());
}

TEST_CASE("FileDialog: a name that exists is saved after a second press only")
{
  Folder folder;
  Names saved;
  FileDialog dialog;
  const auto kind = [](const std::string& path)
  { return fs::path(path).extension() == ".xml" ? std::string("survey") : std::string(); };
  const auto save = [&saved](const std::string& path)
  {
    saved.push_back(path);
    return helios::Status();
  };
  dialog.SaveAs((folder.Path / "a.xml").string(), kind, save);
  CHECK(dialog.GetText() == "a.xml");
  dialog.OnKey("Return", '\r');
  CHECK(dialog.GetHint() == "a.xml exists: save again to replace it");
  CHECK(saved.empty());
  dialog.OnKey("Return", '\r');
  CHECK(saved == Names{ (folder.Path / "a.xml").string() });

  dialog.SaveAs((folder.Path / "a.xml").string(), kind, save);
  dialog.OnKey("Return", '\r');
  dialog.OnKey("BackSpace", '\b'); // another name: what was confirmed is no more
  dialog.OnKey("l", 'l');
  dialog.OnKey("Return", '\r');
  CHECK(saved.size() == 1);
  for (int i = 0; i < 5; ++i)
  {
    dialog.OnKey("BackSpace", '\b');
  }
  dialog.OnKey("Return", '\r');
  CHECK(dialog.GetHint() == "write the name of the file");
  for (const char c : std::string("sub/new.xml"))
  {
    dialog.OnKey(std::string(1, c), c);
  }
  dialog.OnKey("Return", '\r');
  CHECK(saved.back() == (folder.Path / "sub/new.xml").string());
}

TEST_CASE("FileDialog: long lists follow the selection and the wheel")
{
  Folder folder;
  for (int i = 0; i < 60; ++i)
  {
    folder.Write("cloud" + std::to_string(100 + i) + ".xyz", "1 2 3\n");
  }
  FileDialog dialog;
  dialog.Open((folder.Path / "cloud150.xyz").string(), FindInputKind,
    [](const std::string&) { return helios::Status(); });
  CHECK(dialog.GetList().GetEntry()->Name == "cloud150.xyz"); // the one that is shown
  dialog.OnKey("End", 0);
  CHECK(dialog.GetList().GetEntry()->Name == "yard.las");
  CHECK_FALSE(dialog.GetRow(Place, dialog.GetList().GetSelected(), Size).IsEmpty());
  CHECK(dialog.GetRow(Place, 0, Size).IsEmpty());
  dialog.OnWheel(-1000);
  CHECK_FALSE(dialog.GetRow(Place, 0, Size).IsEmpty());
}

TEST_CASE("FileList: a folder that cannot be read changes nothing")
{
  Folder folder;
  FileList list;
  list.SetKind(FindInputKind);
  REQUIRE(list.SetFolder(folder.Path.string()));
  CHECK_FALSE(list.SetFolder((folder.Path / "none").string()));
  CHECK(list.GetFolder() == folder.Path.string());
  CHECK(list.GetEntries().size() == 5);
  FileDialog dialog;
  dialog.Open((folder.Path / "none" / "a.xml").string(), FindInputKind, nullptr);
  CHECK_THAT(dialog.GetHint(), Contains("none: this folder cannot be read"));
}
