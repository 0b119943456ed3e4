#!/bin/sh
# ncverify-page.t - ncverify's page in a browser: drawn, turned and searched by the keyboard and the
# pointer, nothing loaded from elsewhere.  Needs chromium (`make deps`).
. "${SRC:-$(dirname "$0")/../..}/tests/lib/lib.sh"
cd "$TMP" || exit 1
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome)
face=$SRC/samples/face_nefertiti_26493.xyz
nc=$TMP/face.mpf

sh -c "cloud2mesh --nodes scan -q -t 5 '$face' | meshnorm -q -r 5 --rows mesh --one-way --avoid -g '$face' | ncpost -q -c siemens" >"$nc"
# A gouge of 0.5 mm in one block: the 200th with the tool upright goes deeper than its neighbours.
awk '/^N[0-9]+ .*Z-?[0-9.]+/ && /C3=0\.9[5-9]/ && ++n == 200 {
	match($0, /Z-?[0-9.]+/)
	z = substr($0, RSTART + 1, RLENGTH - 1) - 0.5
	$0 = substr($0, 1, RSTART) z substr($0, RSTART + RLENGTH)
	print > "block"
} { print }' "$nc" >gouged.mpf
# The ball is deepest at its end: in that block or the next.
blocks=$(grep -A 1 -F -x -f block gouged.mpf | sed 's/^\(N[0-9]*\) .*/\1/' | paste -s -d '|')
status 3 "the gouged program is refused" \
	ncverify -q -g "$face" -r 5 -e 0.1 --partial --report page.html gouged.mpf
bad=$(ncverify -q -g "$face" -r 5 -e 0.1 --partial gouged.mpf 2>&1 |
	sed -n 's/^.*fault *\(N[0-9]*\) .*/\1/p' | head -n 1)
echo "$bad" >bad
has "the gouged block is named, or the next" "^($blocks)\$" bad
hasnt "the page loads nothing" '(src|href)=|https?:|url\(|@import|fetch\(|XMLHttp' page.html
has "and is whole" '^</script>$' page.html

[ -n "$browser" ] || skip_rest "no chromium"

# What a person would do, and what they would then see, as lines of text in the page's body.
cat >steps.js <<'EOF'
<script>
const canvasSum = () => {
  const pixels = pen.getImageData(0, 0, canvas.width, canvas.height).data;
  let sum = 0, red = 0, green = 0;
  for (let i = 0; i < pixels.length; i += 4) {
    sum = (sum * 31 + pixels[i] + 7 * pixels[i + 1] + 13 * pixels[i + 2]) % 1000003;
    red += pixels[i] > 180 && pixels[i + 1] < 90 && pixels[i + 2] < 90;
    green += pixels[i + 1] > 120 && pixels[i] < 120;
  }
  return {sum, red, green};
};
const said = [];
const key = (name, shift) => {
  canvas.dispatchEvent(new KeyboardEvent('keydown', {key: name, shiftKey: !!shift, bubbles: true}));
  draw();
};
const tell = what => said.push(what + ': ' + info.textContent);
// The window may take its size late: what is drawn must not hang on that.
canvas.style.cssText = 'width: 855px; height: 532px; flex: none';
draw();
tell('start');
const first = canvasSum();
said.push('green ' + first.green + ', red ' + first.red);
for (const [name, shift] of [['ArrowLeft'], ['ArrowUp'], ['ArrowRight', 1], ['+'], ['t'], ['f']]) {
  const before = canvasSum().sum;
  key(name, shift);
  said.push('key ' + name + (canvasSum().sum === before ? ' does nothing' : ' changes the view'));
}
key('0');
key('n');
tell('n');
key('p');
tell('p');
key(']');
tell('pass');
said.push('pressed: ' + passes.filter(b => b.getAttribute('aria-pressed') === 'true').length);
key('Escape');
tell('escape');
const input = document.getElementById('find');
input.value = 'BLOCK';
input.dispatchEvent(new Event('change'));
tell('find');
const box = canvas.getBoundingClientRect();
const point = (type, x, y) => canvas.dispatchEvent(new PointerEvent(type,
  {clientX: x, clientY: y, pointerId: 1, bubbles: true, buttons: 1}));
const before = canvasSum().sum;
canvas.setPointerCapture = () => {};
point('pointerdown', box.left + 100, box.top + 100);
point('pointermove', box.left + 160, box.top + 120);
point('pointerup', box.left + 160, box.top + 120);
draw();
said.push(canvasSum().sum === before ? 'drag does nothing' : 'drag turns');
key('Escape');
point('pointerdown', box.left + box.width / 2, box.top + box.height / 2);
point('pointerup', box.left + box.width / 2, box.top + box.height / 2);
tell('click');
document.querySelector('#points').click();
draw();
said.push('without points green ' + canvasSum().green);
said.push('reachable by Tab: ' + document.querySelectorAll('canvas[tabindex="0"],button,input').length);
const list = document.createElement('pre');
list.id = 'said';
list.textContent = said.join('\n');
document.body.appendChild(list);
</script>
EOF
sed "s/BLOCK/$bad/" steps.js >block.js
awk 'FNR == NR { steps = steps $0 "\n"; next } /^<\/body>/ { printf "%s", steps } { print }' \
	block.js page.html >driven.html
chrome() {
	timeout 120 "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$TMP/profile" \
		--window-size=1300,900 "$@" 2>browser.err
}
chrome --dump-dom "file://$TMP/driven.html" >dom
sed -n '/<pre id="said">/,/<\/pre>/p' dom | sed 's/<[^>]*>//g' >said
has "it starts at the worst block, the one gouged" "^start: $bad .*gouge 0\.[3-5]" said
green=$(sed -n 's/^green \([0-9]*\),.*/\1/p' said)
red=$(sed -n 's/.*, red \([0-9]*\)$/\1/p' said)
below "the part is drawn, in green" 5000 "${green:-0}"
below "the gouge in red" 5 "${red:-0}"
for key in ArrowLeft ArrowUp ArrowRight '\+' t f; do
	has "key $key" "^key $key changes the view\$" said
done
has "n goes to another block" '^n: N[0-9]+ .*left' said
has "p goes back" "^p: $bad " said
has "] goes to the next cut" '^pass: cut [0-9]+: gouge 0\.[0-9]+, left 0\.[0-9]+, [0-9.]+ mm, N' said
has "its button is down" '^pressed: 1$' said
has "Esc takes it back" '^escape: Nothing is chosen.$' said
has "a block is found by its number" "^find: $bad .*gouge 0\.[3-5]" said
has "the pointer turns the part" '^drag turns$' said
has "a click chooses what is there" '^click: N[0-9]+ .*at -?[0-9.]+ -?[0-9.]+ [0-9.]+$' said
below "points can be left out" \
	"$(sed -n 's/^without points green \([0-9]*\)$/\1/p' said)" 2000
below "all can be reached by the keyboard" 20 \
	"$(sed -n 's/^reachable by Tab: \([0-9]*\)$/\1/p' said)"

chrome --screenshot="$TMP/page.png" "file://$TMP/page.html" >/dev/null
below "a screenshot of it is a picture" 20000 "$(wc -c <page.png)"
done_testing
