# SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
# SPDX-License-Identifier: BSD-3-Clause
# Makes vtkhelios/webcloud/page/twgl.js: the parts of twgl.js that the page uses, in one file.
# Needs npm, and its registry; only to change the version. --check compares instead.
set -euo pipefail

twgl=twgl.js@7.0.0
integrity=sha512-9HHZ8emdZb2nKPU0FDIGDlkp6AD9rWFv7ThqdbmUqyBhD3WTQpLN+89w4B+YshGwD1fL6PMVpVKZqC0pikgmcA==
esbuild=esbuild@0.25.0
page=$(cd "$(dirname "$0")" && pwd)/vtkhelios/webcloud/page

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm init -y >/dev/null
npm install --silent --no-audit --no-fund "$twgl" "$esbuild"
node -e '
  const lock = require("./package-lock.json").packages["node_modules/twgl.js"];
  if (lock.integrity !== process.argv[1]) throw new Error("twgl.js has another checksum: " + lock.integrity);
' "$integrity"
echo 'export { bindFramebufferInfo, createFramebufferInfo, createProgramInfo, createTexture, m4, resizeFramebufferInfo,
  setTextureFromArray, setUniforms } from "twgl.js";' >page.js
{
  echo "// $twgl from npm, bundled by Python/make_twgl.sh; do not edit."
  echo "// SPDX-License-Identifier: MIT"
  npx esbuild page.js --bundle --minify --format=esm --target=es2022 --legal-comments=none
} >twgl.js
if [ "${1:-}" = --check ]; then
  cmp twgl.js "$page/twgl.js"
else
  cp twgl.js "$page/twgl.js"
  cp node_modules/twgl.js/LICENSE.md "$page/twgl-license.txt"
fi
