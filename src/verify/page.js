'use strict';
const canvas = document.getElementById('view'), pen = canvas.getContext('2d');
const passes = [...document.querySelectorAll('button[data-pass]')];
const info = document.getElementById('info'), N = D.points.length / 6, M = D.nodes.length / 5;
let turn = 0.6, tilt = 0.9, zoom = 1, shift = [0, 0], chosen = -1, spot = -1, pass = -1;
const show = {points: true, path: true, rapid: true, speed: false};
let size = 1;
for (let i = 0; i < N; i++)
  size = Math.max(size, Math.hypot(D.points[6 * i], D.points[6 * i + 1], D.points[6 * i + 2]));
// The view: about z by turn, then about the screen's x by tilt; y of the screen points down.
function frame() {
  const c = Math.cos(turn), s = Math.sin(turn), u = Math.cos(tilt), v = Math.sin(tilt);
  const scale = 0.5 * Math.min(canvas.width, canvas.height) / size * zoom;
  const x0 = canvas.width / 2 + shift[0], y0 = canvas.height / 2 + shift[1];
  return (x, y, z) => {
    const a = c * x - s * y, b = s * x + c * y;
    return [x0 + scale * a, y0 - scale * (u * b + v * z), u * z - v * b];
  };
}
function colour(d, inside) {
  if (!inside) return [130, 130, 130];
  const to = d < 0 ? [220, 30, 30] : [40, 90, 220];
  const share = Math.min(1, d < 0 ? -d / D.tolerance : d / D.full);
  return [70, 170, 90].map((g, k) => Math.round(g + share * (to[k] - g)));
}
function drawPoints(at) {
  const w = canvas.width, h = canvas.height, image = pen.createImageData(w, h);
  const pixel = new Uint32Array(image.data.buffer), depth = new Float32Array(w * h).fill(-1e30);
  const r = Math.max(2, Math.min(12, Math.round(zoom * 1.2 * Math.sqrt(w * h / Math.max(1, N)))));
  for (let i = 0; i < N; i++) {
    const p = at(D.points[6 * i], D.points[6 * i + 1], D.points[6 * i + 2]);
    const x0 = Math.round(p[0] - r / 2), y0 = Math.round(p[1] - r / 2);
    const c = colour(D.points[6 * i + 3], D.points[6 * i + 4]);
    const value = (255 << 24 | c[2] << 16 | c[1] << 8 | c[0]) >>> 0;
    for (let y = Math.max(0, y0); y < Math.min(h, y0 + r); y++)
      for (let x = Math.max(0, x0); x < Math.min(w, x0 + r); x++)
        if (p[2] > depth[y * w + x]) {
          depth[y * w + x] = p[2];
          pixel[y * w + x] = value;
        }
  }
  pen.putImageData(image, 0, 0);
}
// By the speed, in hundredths of the feed: red stands, yellow is half of it, green all of it.
function swift(speed) {
  return 'hsl(' + (speed === undefined ? 0 : Math.min(120, 1.2 * speed)) + ',90%,40%)';
}
function drawPath(at) {
  for (let i = 1; i < M; i++) {
    const kind = D.nodes[5 * i + 3], row = D.nodes[5 * i + 4];
    if (kind === 0 || (kind === 1 ? !show.path : !show.rapid)) continue;
    const here = row === chosen, mine = kind === 1 && D.rows[5 * row + 2] === pass;
    const a = at(D.nodes[5 * i - 5], D.nodes[5 * i - 4], D.nodes[5 * i - 3]);
    const b = at(D.nodes[5 * i], D.nodes[5 * i + 1], D.nodes[5 * i + 2]);
    pen.beginPath();
    pen.setLineDash(kind === 2 ? [5, 4] : []);
    pen.strokeStyle = here ? '#ffd400' : mine ? '#e07800' : kind === 2 ? '#c060c0' :
      show.speed ? swift(D.speed[row]) :
      pass < 0 ? 'rgba(20,20,20,0.35)' : 'rgba(20,20,20,0.1)';
    pen.lineWidth = here ? 4 : mine ? 2 : 1;
    pen.moveTo(a[0], a[1]);
    pen.lineTo(b[0], b[1]);
    pen.stroke();
  }
  pen.setLineDash([]);
}
function ring(at, i) {
  const p = at(D.points[6 * i], D.points[6 * i + 1], D.points[6 * i + 2]);
  pen.beginPath();
  pen.strokeStyle = '#ffd400';
  pen.lineWidth = 3;
  pen.arc(p[0], p[1], 9, 0, 7);
  pen.stroke();
}
function draw() {
  const box = canvas.getBoundingClientRect();
  canvas.width = Math.max(200, Math.round(box.width));
  canvas.height = Math.max(200, Math.round(box.height));
  const at = frame();
  if (show.points) drawPoints(at);
  drawPath(at);
  if (spot >= 0) ring(at, spot);
}
let waiting = false;
function redraw() {
  if (waiting) return;
  waiting = true;
  requestAnimationFrame(() => { waiting = false; draw(); });
}
function mm(v) { return (v / 10000).toFixed(4) + ' mm'; }
function name(row) {
  const b = D.rows[5 * row], line = 'line ' + D.rows[5 * row + 1];
  return b < 0 ? line : 'N' + b + ' (' + line + ')';
}
// Of a pass, or of none, the button is down.
function press(number) {
  pass = number;
  for (const button of passes)
    button.setAttribute('aria-pressed', Number(button.dataset.pass) === number);
}
// A pass is chosen: from the table, or by the brackets.
function choosePass(number) {
  const button = passes.find(b => Number(b.dataset.pass) === number);
  choose(-1, -1);
  if (!button) return;
  press(number);
  info.textContent = button.textContent + ', ' + button.title;
  redraw();
}
// A block is chosen: from the table, by a click, by its number, or by n and p.
function choose(row, point) {
  chosen = row;
  spot = point;
  press(-1);
  if (row < 0) { info.textContent = 'Nothing is chosen.'; redraw(); return; }
  pass = D.rows[5 * row + 2];
  if (spot < 0) {
    let worst = -1e30;
    for (let i = 0; i < N; i++) {
      const d = D.points[6 * i + 3];
      if (D.points[6 * i + 5] !== row || !D.points[6 * i + 4]) continue;
      const bad = d < -D.tolerance ? 1e9 - d : d;
      if (bad > worst) { worst = bad; spot = i; }
    }
  }
  info.textContent = name(row) + ', cut ' + D.rows[5 * row + 2] + ': gouge ' +
    mm(D.rows[5 * row + 3]) + ', left ' + mm(D.rows[5 * row + 4]) +
    (D.speed[row] < 99 ? ', ' + D.speed[row] + ' % of the feed' : '') +
    (spot >= 0 ? '; here ' + mm(D.points[6 * spot + 3]) + ' at ' + [0, 1, 2].map(k =>
      ((D.points[6 * spot + k] + D.centre[k]) / 1000).toFixed(3)).join(' ') : '');
  redraw();
}
function pick(x, y) {
  const at = frame();
  let best = 200, point = -1, high = -1e30;
  for (let i = 0; i < N; i++) {
    const p = at(D.points[6 * i], D.points[6 * i + 1], D.points[6 * i + 2]);
    const d = (p[0] - x) * (p[0] - x) + (p[1] - y) * (p[1] - y);
    if (d < 36 && p[2] > high) { high = p[2]; point = i; }
  }
  let row = point >= 0 ? D.points[6 * point + 5] : -1;
  if (point < 0)
    for (let i = 0; i < M; i++) {
      const p = at(D.nodes[5 * i], D.nodes[5 * i + 1], D.nodes[5 * i + 2]);
      const d = (p[0] - x) * (p[0] - x) + (p[1] - y) * (p[1] - y);
      if (d < best) { best = d; row = D.nodes[5 * i + 4]; }
    }
  choose(row, point);
}
let drag = null, moved = 0;
canvas.addEventListener('pointerdown', e => {
  drag = [e.clientX, e.clientY];
  moved = 0;
  canvas.setPointerCapture(e.pointerId);
});
canvas.addEventListener('pointermove', e => {
  if (!drag) return;
  const dx = e.clientX - drag[0], dy = e.clientY - drag[1];
  moved += Math.abs(dx) + Math.abs(dy);
  drag = [e.clientX, e.clientY];
  if (e.shiftKey || e.buttons & 2) { shift[0] += dx; shift[1] += dy; }
  else { turn -= dx / 150; tilt = Math.max(-1.57, Math.min(1.57, tilt + dy / 150)); }
  redraw();
});
canvas.addEventListener('pointerup', e => {
  drag = null;
  const box = canvas.getBoundingClientRect();
  if (moved < 4) pick(e.clientX - box.left, e.clientY - box.top);
});
canvas.addEventListener('contextmenu', e => e.preventDefault());
canvas.addEventListener('wheel', e => {
  e.preventDefault();
  zoom *= Math.exp(-e.deltaY / 600);
  redraw();
}, {passive: false});
let place = -1;
function step(by) {
  if (!D.worst.length) return;
  place = (place + by + D.worst.length) % D.worst.length;
  choose(D.worst[place], -1);
}
function stepPass(by) {
  if (!passes.length) return;
  const at = passes.findIndex(b => Number(b.dataset.pass) === pass);
  const next = at < 0 && by < 0 ? passes.length - 1 : (at + by + passes.length) % passes.length;
  choosePass(Number(passes[next].dataset.pass));
}
function find(number) {
  for (let row = 0; 5 * row < D.rows.length; row++)
    if (D.rows[5 * row] === number) { choose(row, -1); return; }
  choose(-1, -1);
  info.textContent = 'Block N' + number + ' is not among those drawn.';
}
function toggle(what) {
  show[what] = !show[what];
  document.getElementById(what).setAttribute('aria-pressed', show[what]);
  redraw();
}
const keys = {
  ArrowLeft: e => { if (e.shiftKey) shift[0] -= 20; else turn -= 0.1; },
  ArrowRight: e => { if (e.shiftKey) shift[0] += 20; else turn += 0.1; },
  ArrowUp: e => { if (e.shiftKey) shift[1] -= 20; else tilt = Math.min(1.57, tilt + 0.1); },
  ArrowDown: e => { if (e.shiftKey) shift[1] += 20; else tilt = Math.max(-1.57, tilt - 0.1); },
  '+': () => { zoom *= 1.2; }, '=': () => { zoom *= 1.2; }, '-': () => { zoom /= 1.2; },
  '0': () => { turn = 0.6; tilt = 0.9; zoom = 1; shift = [0, 0]; },
  t: () => { turn = 0; tilt = 0; }, f: () => { turn = 0; tilt = 1.57; },
  n: () => step(1), p: () => step(-1), ']': () => stepPass(1), '[': () => stepPass(-1),
  Escape: () => choose(-1, -1)
};
canvas.addEventListener('keydown', e => {
  const act = keys[e.key];
  if (!act || e.ctrlKey || e.altKey || e.metaKey) return;
  e.preventDefault();
  act(e);
  redraw();
});
for (const what of ['points', 'path', 'rapid', 'speed'])
  document.getElementById(what).addEventListener('click', () => toggle(what));
for (const button of document.querySelectorAll('button[data-row]'))
  button.addEventListener('click', () => {
    place = D.worst.indexOf(Number(button.dataset.row));
    choose(Number(button.dataset.row), -1);
  });
for (const button of passes)
  button.addEventListener('click', () => choosePass(Number(button.dataset.pass)));
document.getElementById('find').addEventListener('change', e => {
  const number = parseInt(e.target.value.replace(/^\s*N/i, ''), 10);
  if (number >= 0) find(number);
});
window.addEventListener('resize', redraw);
draw();
if (D.worst.length) step(1);
