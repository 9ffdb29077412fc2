// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRankMessage.h"

#include "heliosRunProgress.h"

namespace helios
{

//------------------------------------------------------------------------------
std::string RankMessage::Encode() const
{
  Json::Value head;
  head["kind"] = this->Kind;
  head["run"] = this->Run;
  head["epoch"] = this->Epoch;
  head["leg"] = this->Leg;
  head["index"] = Json::Int64(this->Index);
  head["counts"] = ToJson(this->Counts);
  head["fingerprint"] = this->Fingerprint;
  head["error"] = this->Error;
  head["records"] = Json::arrayValue;
  std::size_t size = 0;
  for (const RankRecords& records : this->Records)
  {
    Json::Value& entry = head["records"].append(Json::objectValue);
    entry["count"] = Json::Int64(records.Count);
    entry["bytes"] = Json::UInt64(records.Bytes.size());
    size += records.Bytes.size();
  }
  std::string text = ToLine(head) + "\n";
  text.reserve(text.size() + size);
  for (const RankRecords& records : this->Records)
  {
    text += records.Bytes;
  }
  return text;
}

//------------------------------------------------------------------------------
bool RankMessage::Decode(const std::string& text)
{
  std::size_t at = text.find('\n');
  Json::Value head;
  if (at == std::string::npos || !FromText(text.substr(0, at), head))
  {
    return false;
  }
  ++at;
  this->Kind = head["kind"].asString();
  this->Run = head["run"].asInt();
  this->Epoch = head["epoch"].asInt();
  this->Leg = head["leg"].asInt();
  this->Index = head["index"].asInt64();
  this->Counts = CountsFromJson(head["counts"]);
  this->Fingerprint = head["fingerprint"].asString();
  this->Error = head["error"].asString();
  this->Records.clear();
  for (const Json::Value& entry : head["records"])
  {
    const auto size = static_cast<std::size_t>(entry["bytes"].asUInt64());
    this->Records.push_back({ entry["count"].asInt64(), text.substr(at, size) });
    at += size;
  }
  return at == text.size();
}

} // namespace helios
