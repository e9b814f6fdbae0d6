// Holds a file of glTF and one of CityJSON against their validators, and the second one against areas of the tables, in m2:
// node validate.mjs SCHEMA FILE.glb FILE.city.json ROADWAY SIDEWALKS prints "t or f, name"; figures go to stderr. SCHEMA - is none.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename } from 'node:path';
const require = createRequire(process.cwd() + '/');
const [schema, solid, city, roadway, sidewalks] = process.argv.slice(2);
const say = (holds, name) => console.log(`${holds ? 't' : 'f'}\t${name}`);

async function holdGltf(file) {
  const { validateBytes } = require('gltf-validator');
  const { issues } = await validateBytes(new Uint8Array(readFileSync(file)), { ignoredIssues: ['UNUSED_OBJECT'] });
  const worst = issues.messages.slice(0, 3).map((issue) => JSON.stringify(issue)).join('\n');
  say(issues.numErrors + issues.numWarnings === 0, `${basename(file)}: no error and no warning of gltf-validator`);
  if (worst) console.error(worst);
}

function holdSchema(file, value) {
  if (schema === '-') return console.log(`s\t${basename(file)}: valid by the schema of CityJSON`);
  const Ajv = require('ajv').default;
  const ajv = new Ajv({ strict: false });
  require('ajv-formats').default(ajv);
  const holds = ajv.compile(JSON.parse(readFileSync(schema)));
  say(holds(value), `${basename(file)}: valid by the schema of CityJSON`);
}

// Area in plan by function, and sides of kerbs without a triangle on their other side.
function measure({ vertices, CityObjects }) {
  const area = {}, sides = new Map();
  let triangles = 0;
  for (const { geometry: [{ boundaries, semantics }] } of Object.values(CityObjects))
    boundaries.forEach(([ring], place) => {
      triangles++;
      const { function: of } = semantics.surfaces[semantics.values[place]];
      const [a, b, c] = ring.map((vertex) => vertices[vertex]);
      area[of] = (area[of] ?? 0) + ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) / 2;
      ring.forEach((from, k) => {
        const side = `${from} ${ring[(k + 1) % 3]}`;
        sides.set(side, sides.get(side) === 'kerbstone' ? 'kerbstone' : of);
      });
    });
  let kerb = 0, open = 0;
  for (const [side, of] of sides) {
    if (of !== 'kerbstone') continue;
    const [from, to] = side.split(' ');
    const [a, b] = [vertices[from], vertices[to]];
    if (a[0] === b[0] && a[1] === b[1]) continue;
    kerb++;
    if (!sides.has(`${to} ${from}`)) open++;
  }
  return { area, triangles, kerb, open };
}

await holdGltf(solid);
const value = JSON.parse(readFileSync(city));
holdSchema(city, value);
const { area, triangles, kerb, open } = measure(value);
const name = basename(city), square = value.transform.scale[0] ** 2;
const near = (have, want) => Math.abs((have ?? 0) * square - want) <= 1e-3 * want;
say(near(area.roadway, Number(roadway)), `${name}: the roadway has the area of the tables`);
say(near(area.footpath, Number(sidewalks)), `${name}: sidewalks have the area of the tables`);
say(new Set(value.vertices.map(String)).size === value.vertices.length, `${name}: no place has two vertices`);
console.error(`${name}: ${triangles} triangles; roadway ${((area.roadway * square) / roadway - 1).toExponential(1)}, sidewalks ${(((area.footpath ?? 0) * square) / sidewalks - 1).toExponential(1)} off; ` +
  `${open} of ${kerb} level sides of kerbs are open`);
