// Holds files of CityJSON and glTF against their validators: node validate.mjs SCHEMA FILE… prints "t or f, name" for each.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
const require = createRequire(process.cwd() + '/');
const Ajv = require('ajv').default;
const addFormats = require('ajv-formats').default;
const { validateBytes } = require('gltf-validator');
const [schema, ...files] = process.argv.slice(2);

const ajv = new Ajv({ strict: false, allErrors: false });
addFormats(ajv);
const isCityJson = ajv.compile(JSON.parse(readFileSync(schema)));
const say = (holds, name) => console.log(`${holds ? 't' : 'f'}\t${name}`);

for (const file of files) {
  const name = file.split('/').pop();
  if (file.endsWith('.glb')) {
    const report = await validateBytes(new Uint8Array(readFileSync(file)), { maxIssues: 20 });
    const { numErrors, numWarnings, numInfos, numHints } = report.issues;
    say(numErrors + numWarnings === 0, `${name}: no error and no warning of gltf-validator`);
    console.error(`${name}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ${numHints} hints; ${report.info?.totalTriangleCount} triangles`);
    for (const issue of report.issues.messages.slice(0, 5)) console.error(JSON.stringify(issue));
  } else {
    const city = JSON.parse(readFileSync(file));
    say(isCityJson(city), `${name}: valid by the schema of CityJSON`);
    if (isCityJson.errors) console.error(JSON.stringify(isCityJson.errors.slice(0, 3)));
    const used = new Set();
    let surfaces = 0;
    for (const object of Object.values(city.CityObjects))
      for (const geometry of object.geometry)
        for (const [ring] of geometry.boundaries) { surfaces++; for (const vertex of ring) used.add(vertex); }
    say(used.size === city.vertices.length, `${name}: every vertex is used`);
    say(new Set(city.vertices.map(String)).size === city.vertices.length, `${name}: no place has two vertices`);
    console.error(`${name}: ${Object.keys(city.CityObjects).length} roads, ${surfaces} triangles, ${city.vertices.length} vertices`);
  }
}
