// Runs a WebAssembly program with node's system interface.
import { readFile } from 'node:fs/promises';
import { argv } from 'node:process';
import { WASI } from 'node:wasi';

const wasi = new WASI({ version: 'preview1' });
const { instance } = await WebAssembly.instantiate(await readFile(argv[2]), wasi.getImportObject());
wasi.start(instance);
