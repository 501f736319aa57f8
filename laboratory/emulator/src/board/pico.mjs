// Runs a program on an emulated Raspberry Pi Pico with an LCD: see lcd.mjs. Its orders also have presses: [[picture, down], …], pictures after which the button goes down or up.
import { play } from './lcd.mjs';

const BUTTON = 15;

await play({ spi: 0, data: 16, select: 17, reset: 20 }, (chip, { presses }) => {
    const press = (down) => chip.gpio[BUTTON].setInputValue(!down);
    press(false);
    return {
        shown(picture) { for (const [at, down] of presses) if (at === picture) press(down); },
        isBusy: () => false,
        seen: () => ({}),
    };
});
