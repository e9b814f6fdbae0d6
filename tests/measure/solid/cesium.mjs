// A folder of 3D Tiles in CesiumJS in Chromium: node cesium.mjs FOLDER PICTURE.png, from a folder whose node_modules has cesium and puppeteer-core.
// Prints the tiles that were loaded, triangles that are drawn, and errors; fails where one tile fails or none comes.
import { createServer } from 'node:http'
import { createReadStream, existsSync } from 'node:fs'
import { createRequire } from 'node:module'
import { dirname, extname, join } from 'node:path'
const [folder, picture] = process.argv.slice(2)
const require = createRequire(join(process.cwd(), 'package.json'))
const puppeteer = require('puppeteer-core')
const cesium = join(dirname(require.resolve('cesium/package.json')), 'Build/Cesium')
const types = { '.js': 'text/javascript', '.json': 'application/json', '.wasm': 'application/wasm', '.css': 'text/css', '.html': 'text/html' }
const page = `<link rel="stylesheet" href="/cesium/Widgets/widgets.css"><div id="globe" style="width:1400px;height:900px"></div>
<script>window.CESIUM_BASE_URL = '/cesium/'</script><script src="/cesium/Cesium.js"></script><script>(async () => {
  const viewer = new Cesium.Viewer('globe', { baseLayer: false, baseLayerPicker: false, geocoder: false, animation: false, timeline: false })
  const said = { failed: [] }
  const tiles = viewer.scene.primitives.add(await Cesium.Cesium3DTileset.fromUrl('/tiles/tileset.json'))
  tiles.tileFailed.addEventListener(error => said.failed.push(error.message))
  tiles.allTilesLoaded.addEventListener(() => setTimeout(() => { said.loaded = tiles.statistics.numberOfTilesWithContentReady; said.triangles = tiles.statistics.numberOfTrianglesSelected; window.said = said }, 5000))
  await viewer.zoomTo(tiles, new Cesium.HeadingPitchRange(0.6, -0.6, 900))
})().catch(error => { window.said = { failed: [String(error)] } })</script>`
const server = createServer((request, answer) => {
  const url = request.url.split('?')[0]
  if (url === '/') return answer.setHeader('content-type', types['.html']).end(page)
  const file = url.startsWith('/cesium/') ? join(cesium, url.slice(8)) : url.startsWith('/tiles/') ? join(folder, url.slice(7)) : ''
  if (!existsSync(file)) return answer.writeHead(404).end()
  answer.setHeader('content-type', types[extname(file)] ?? 'application/octet-stream')
  createReadStream(file).pipe(answer)
}).listen(0)
const browser = await puppeteer.launch({ executablePath: '/usr/bin/chromium', protocolTimeout: 300000, args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'] })
const tab = await browser.newPage()
await tab.setViewport({ width: 1400, height: 900 })
await tab.goto(`http://localhost:${server.address().port}/`)
await tab.waitForFunction('window.said', { timeout: 240000 })
const said = await tab.evaluate('window.said')
await tab.screenshot({ path: picture })
await browser.close()
server.close()
console.log(JSON.stringify(said))
process.exitCode = said.failed.length === 0 && said.loaded > 0 ? 0 : 1
