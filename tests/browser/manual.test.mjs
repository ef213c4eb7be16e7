// Reads the manual's site (tools/manual.sh --base /islet/) as a visitor does, from a server of files that has it under /islet/.
// Environment: CHROMIUM, the browser; MANUAL, the built folder.
import assert from 'node:assert/strict';
import {existsSync, readFileSync, readdirSync, statSync, symlinkSync} from 'node:fs';
import {dirname, join, normalize} from 'node:path';
import {describe, test} from 'node:test';
import {axeFindings, server, temporaryFolder, useBrowser, visit} from './browser.mjs';

const site = process.env.MANUAL;
const root = temporaryFolder('manual');
const sizes = {phone: {viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true}, tablet: {viewport: {width: 820, height: 1100}}, desktop: {viewport: {width: 1440, height: 900}}};

symlinkSync(site, join(root, 'islet'));
useBrowser(root);

const withPage = (name, options, use) => visit(`${server.address}islet/${name}`, {
    options,
    mayAsk: (url) => url.startsWith(`${server.address}islet/`) || /^(data|blob):/.test(url),
}, use);

const stepOf = (page) => page.evaluate(() => Number(document.querySelector('islet-world').dataset.step));

test('every link of every page leads to a page, and to a heading of it if it names one', () => {
    const files = readdirSync(site, {recursive: true}).filter((name) => name.endsWith('.html'));
    const texts = new Map(files.map((name) => [name, readFileSync(join(site, name), 'utf8')]));
    const wrong = [];
    let checked = 0;
    for (const [name, text] of texts) {
        for (const [, link] of text.matchAll(/<(?:a|link|script|img)\b[^>]*?\s(?:href|src)="([^"]+)"/g)) {
            if (/^(https?|data|mailto):/.test(link)) continue;
            ++checked;
            const [path, anchor] = link.replaceAll('&amp;', '&').split('#');
            let target = path === '' ? name : path.startsWith('/islet/') ? path.slice('/islet/'.length) : path.startsWith('/') ? `outside${path}` : join(dirname(name), path);
            target = normalize(decodeURIComponent(target === '' ? 'index.html' : target));
            if (existsSync(join(site, target)) && statSync(join(site, target)).isDirectory()) target = join(target, 'index.html');
            if (!existsSync(join(site, target))) wrong.push(`${name}: ${link}`);
            else if (anchor && !texts.get(target)?.includes(`id="${decodeURIComponent(anchor)}"`)) wrong.push(`${name}: ${link} names no heading`);
        }
    }
    assert.deepEqual(wrong, []);
    assert.ok(files.length > 100 && checked > 3000, `${checked} links of ${files.length} pages`);
});

test('pages fit phones, tablets and desktops', async () => {
    for (const size of Object.values(sizes)) {
        for (const name of size === sizes.phone ? ['', 'pgs.html', 'matter-js.html', 'reference/world.html'] : ['', 'pgs.html']) {
            await withPage(name, size, async (page) => {
                assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= size.viewport.width, `${name} at ${size.viewport.width}`);
            });
        }
    }
});

describe('a world in a page', () => {
    test('runs where the picture stood, and its bodies can be dragged', async () => {
        await withPage('javascript.html', sizes.desktop, async (page) => {
            await page.waitForFunction(() => document.querySelector('islet-world')?.dataset.step > 20);
            await page.click('islet-world button[title="Pause"]');
            const paused = await stepOf(page);
            const picture = () => page.evaluate(() => document.querySelector('islet-world canvas').toDataURL());
            const before_ = await picture();
            // Up from the ground until there is a card.
            const box = await page.locator('islet-world canvas').boundingBox();
            for (let y = 0.85; (await stepOf(page)) === paused && y > 0.2; y -= 0.005) {
                await page.mouse.move(box.x + 0.5 * box.width, box.y + y * box.height);
                await page.mouse.down();
                await page.mouse.move(box.x + 0.8 * box.width, box.y + 0.2 * box.height, {steps: 3});
                await page.waitForTimeout(50);
                await page.mouse.up();
            }
            await page.waitForFunction((step) => document.querySelector('islet-world').dataset.step > step + 20, paused);
            assert.notEqual(await picture(), before_);
        });
    });

    test('waits for those who want no motion', async () => {
        await withPage('javascript.html', {...sizes.desktop, reducedMotion: 'reduce'}, async (page) => {
            await page.waitForSelector('islet-world.live');
            await page.waitForTimeout(300);
            assert.equal(await stepOf(page), 0);
            await page.click('islet-world button[title="Play"]');
            await page.waitForFunction(() => document.querySelector('islet-world').dataset.step > 5);
        });
    });
});

test('the sliders of PGS show what the formulas say', async () => {
    await withPage('pgs.html', sizes.desktop, async (page) => {
        const set = (name, value) => page.locator(`islet-pgs [name=${name}]`).fill(String(value));
        const values = () => page.locator('islet-pgs text.value').allTextContents();
        // Two boxes of 1 kg: the solution is (2, 1), and each sweep halves the error, which is 1 after the first.
        await page.waitForSelector('islet-pgs text.value');
        for (const n of [1, 4, 7]) {
            await set('count', n);
            assert.deepEqual(await values(), [`x₀ = ${(2 - 2 ** (1 - n)).toFixed(2)}`, `x₁ = ${(1 - 2 ** -n).toFixed(2)}`]);
        }
        // The upper box rises faster than the lower one falls: nothing pushes it.
        await set('rise', 1.5);
        assert.deepEqual(await values(), ['x₀ = 1.00', 'x₁ = 0.00']);
        // From the solution on, nothing changes.
        await set('rise', 0);
        await set('upper', 1);
        await set('count', 40);
        const slow = await page.locator('islet-pgs .tower text').last().textContent();
        await page.click('islet-pgs [data-start=warm]');
        const warm = await page.locator('islet-pgs .tower text').last().textContent();
        assert.ok(parseFloat(warm.split(' ')[1]) < parseFloat(slow.split(' ')[1]), `${warm} after a warm start, ${slow} from 0`);
    });
});

test('the search finds functions by their names in C++, C and JavaScript', async () => {
    await withPage('guide.html', sizes.desktop, async (page) => {
        for (const words of ['apply_linear_impulse_to_center', 'islet_body_apply_linear_impulse_to_center', 'bodyApplyLinearImpulseToCenter']) {
            // A key that comes before the page listens is lost.
            const input = page.locator('.VPLocalSearchBox input');
            for (let i = 0; i < 60 && !(await input.isVisible()); ++i) {
                await page.keyboard.press('Control+k');
                await input.waitFor({timeout: 2000}).catch(() => {});
            }
            await input.fill(words);
            await page.waitForSelector('.VPLocalSearchBox .result');
            const found = await page.locator('.VPLocalSearchBox .result').evaluateAll((results) => results.slice(0, 5).map((result) => result.getAttribute('href')));
            assert.ok(found.some((href) => /reference\/bodies.*apply-linear-impulse/.test(href)), `${words}: ${found}`);
            await page.keyboard.press('Escape');
        }
    });
});

test('the reference shows the language that was chosen, on other pages too', async () => {
    await withPage('reference/bodies.html', sizes.desktop, async (page) => {
        await page.click('.languages button:text-is("C")');
        assert.equal(await page.locator('.signatures .in-cpp:visible').count(), 0);
        assert.ok((await page.locator('.signatures .in-c:visible').count()) > 40);
        await page.click('.VPSidebar a:has-text("Joints")');
        await page.waitForFunction(() => document.querySelector('h1').textContent.startsWith('Joints'));
        assert.equal(await page.locator('.signatures .in-ts:visible').count(), 0);
    });
});

test('axe finds nothing serious, light and dark', async () => {
    for (const colorScheme of ['light', 'dark']) {
        for (const name of ['', 'pgs.html', 'reference/mover.html']) {
            await withPage(name, {...sizes.desktop, colorScheme}, async (page) => {
                assert.deepEqual(await axeFindings(page, ['serious', 'critical']), [], `${name}, ${colorScheme}`);
            });
        }
    }
});
