/**
 * sin, cos, exp and log with the same bits on every machine (SPEC.md section
 * 9; fdlibm 5.3). The functions of `Math` with these names may differ between
 * browsers in their last bits, so nothing here or elsewhere calls them.
 */

/** The double nearest to pi. */
// biome-ignore lint/suspicious/noApproximativeNumericConstant: it is exact
export const PI = 3.141592653589793;

// The two words of a double, the upper one first on every machine.
const words = new DataView(new ArrayBuffer(8));

/** @param {number} x @returns {number} its upper 32 bits, signed */
function highWord(x) {
  words.setFloat64(0, x);
  return words.getInt32(0);
}

/**
 * The double with these two words.
 *
 * @param {number} high upper 32 bits
 * @param {number} low lower 32 bits
 * @returns {number}
 */
function double(high, low) {
  words.setInt32(0, high);
  words.setInt32(4, low);
  return words.getFloat64(0);
}

/** @param {number} x @param {number} high @returns {number} x with that upper word */
function withHighWord(x, high) {
  words.setFloat64(0, x);
  words.setInt32(0, high);
  return words.getFloat64(0);
}

/** @param {number} k from -1022 to 1023 @returns {number} 2^k */
function powerOf2(k) {
  return double((1023 + k) << 20, 0);
}

const TWO24 = powerOf2(24);
const TWO54 = powerOf2(54);
const TWO_M1000 = powerOf2(-1000);
const LEAST_NORMAL = powerOf2(-1022);

const INV_PIO2 = double(0x3fe45f30, 0x6dc9c883);
const PIO2_1 = double(0x3ff921fb, 0x54400000);
const PIO2_1T = double(0x3dd0b461, 0x1a626331);
const PIO2_2 = double(0x3dd0b461, 0x1a600000);
const PIO2_2T = double(0x3ba3198a, 0x2e037073);
const PIO2_3 = double(0x3ba3198a, 0x2e000000);
const PIO2_3T = double(0x397b839a, 0x252049c1);

// biome-ignore format: a table
const NPIO2_HIGH = [
	0x3ff921fb, 0x400921fb, 0x4012d97c, 0x401921fb, 0x401f6a7a, 0x4022d97c, 0x4025fdbb, 0x402921fb,
	0x402c463a, 0x402f6a7a, 0x4031475c, 0x4032d97c, 0x40346b9c, 0x4035fdbb, 0x40378fdb, 0x403921fb,
	0x403ab41b, 0x403c463a, 0x403dd85a, 0x403f6a7a, 0x40407e4c, 0x4041475c, 0x4042106c, 0x4042d97c,
	0x4043a28c, 0x40446b9c, 0x404534ac, 0x4045fdbb, 0x4046c6cb, 0x40478fdb, 0x404858eb, 0x404921fb,
];

// The 24-bit digits of 2/pi.
// biome-ignore format: a table
const TWO_OVER_PI = [
	0xa2f983, 0x6e4e44, 0x1529fc, 0x2757d1, 0xf534dd, 0xc0db62, 0x95993c, 0x439041, 0xfe5163, 0xabdebb, 0xc561b7,
	0x246e3a, 0x424dd2, 0xe00649, 0x2eea09, 0xd1921c, 0xfe1deb, 0x1cb129, 0xa73ee8, 0x8235f5, 0x2ebb44, 0x84e99c,
	0x7026b4, 0x5f7e41, 0x3991d6, 0x398353, 0x39f49c, 0x845f8b, 0xbdf928, 0x3b1ff8, 0x97ffde, 0x05980f, 0xef2f11,
	0x8b5a0a, 0x6d1f6d, 0x367ecf, 0x27cb09, 0xb74f46, 0x3f669e, 0x5fea2d, 0x7527ba, 0xc7ebe5, 0xf17b3d, 0x0739f7,
	0x8a5292, 0xea6bfb, 0x5fb11f, 0x8d5d08, 0x560330, 0x46fc7b, 0x6babf0, 0xcfbc20, 0x9af436, 0x1da9e3, 0x91615e,
	0xe61b08, 0x659985, 0x5f14a0, 0x68408d, 0xffd880, 0x4d7327, 0x310606, 0x1556ca, 0x73a8c9, 0x60e27b, 0xc08c6b,
];

// pi/2 in pieces.
const PIO2_PIECES = [
  double(0x3ff921fb, 0x40000000),
  double(0x3e74442d, 0x00000000),
  double(0x3cf84698, 0x80000000),
  double(0x3b78cc51, 0x60000000),
  double(0x39f01b83, 0x80000000),
];

/**
 * What remPio2 found last: x = n pi/2 + y0 + y1, where the quadrant n is right
 * modulo 4; `itself` where |x| is below pi/4 and y0 is x.
 */
const reduced = { n: 0, y0: 0, y1: 0, itself: false };

/**
 * Reduction to [-pi/4, pi/4] (SPEC.md section 9.1).
 *
 * @param {number} x any double
 * @returns {typeof reduced} one object, used again by the next call
 */
function remPio2(x) {
  const ix = highWord(x) & 0x7fffffff;
  const negative = x < 0;
  const t = negative ? -x : x;
  let n = 0;
  let y0 = x;
  let y1 = 0;
  if (ix <= 0x3fe921fb) {
    // |x| up to about pi/4: x itself
  } else if (ix >= 0x7ff00000) {
    y0 = x - x;
    y1 = y0;
  } else if (ix < 0x4002d97c) {
    let z = t - PIO2_1;
    n = 1;
    if (ix !== 0x3ff921fb) {
      y0 = z - PIO2_1T;
      y1 = z - y0 - PIO2_1T;
    } else {
      z = z - PIO2_2;
      y0 = z - PIO2_2T;
      y1 = z - y0 - PIO2_2T;
    }
  } else if (ix <= 0x413921fb) {
    n = Math.trunc(t * INV_PIO2 + 0.5);
    let r = t - n * PIO2_1;
    let w = n * PIO2_1T;
    y0 = r - w;
    if (n >= 32 || ix === NPIO2_HIGH[n - 1]) {
      const j = ix >> 20;
      if (j - ((highWord(y0) >> 20) & 0x7ff) > 16) {
        let s = r;
        w = n * PIO2_2;
        r = s - w;
        w = n * PIO2_2T - (s - r - w);
        y0 = r - w;
        if (j - ((highWord(y0) >> 20) & 0x7ff) > 49) {
          s = r;
          w = n * PIO2_3;
          r = s - w;
          w = n * PIO2_3T - (s - r - w);
          y0 = r - w;
        }
      }
    }
    y1 = r - y0 - w;
  } else {
    return remPio2Large(t, ix, negative);
  }
  if (negative && n !== 0) {
    n = -n;
    y0 = -y0;
    y1 = -y1;
  }
  reduced.n = n;
  reduced.y0 = y0;
  reduced.y1 = y1;
  reduced.itself = ix <= 0x3fe921fb;
  return reduced;
}

/**
 * The method of Payne and Hanek, for |x| beyond 2^20 pi/2.
 *
 * @param {number} t |x|
 * @param {number} ix its upper word
 * @param {boolean} negative the sign of x
 * @returns {typeof reduced}
 */
function remPio2Large(t, ix, negative) {
  const e0 = (ix >> 20) - 1046;
  let z = withHighWord(t, ix - (e0 << 20));
  const tx = [0, 0, 0];
  for (let i = 0; i < 2; i++) {
    tx[i] = Math.trunc(z);
    z = (z - tx[i]) * TWO24;
  }
  tx[2] = z;
  let nx = 3;
  while (tx[nx - 1] === 0) nx--;

  const jk = 4;
  const jx = nx - 1;
  const jv = Math.max(0, Math.trunc((e0 - 3) / 24));
  let q0 = e0 - 24 * (jv + 1);
  /** @type {number[]} */
  const f = [];
  /** @type {number[]} */
  const q = [];
  /** @type {number[]} */
  const iq = [];
  const sum = (/** @type {number} */ i) => {
    let fw = 0;
    for (let j = 0; j <= jx; j++) fw += tx[j] * f[jx + i - j];
    return fw;
  };
  for (let i = 0; i <= jx + jk; i++) {
    f[i] = jv - jx + i < 0 ? 0 : TWO_OVER_PI[jv - jx + i];
  }
  for (let i = 0; i <= jk; i++) q[i] = sum(i);

  let jz = jk;
  let n = 0;
  let ih = 0;
  for (;;) {
    z = q[jz];
    for (let i = 0; i < jz; i++) {
      const fw = Math.trunc(z / TWO24);
      iq[i] = z - fw * TWO24;
      z = q[jz - 1 - i] + fw;
    }
    z = z * powerOf2(q0);
    z = z - 8 * Math.floor(z / 8);
    n = Math.trunc(z);
    z = z - n;
    ih = 0;
    if (q0 > 0) {
      const i = iq[jz - 1] >> (24 - q0);
      n += i;
      iq[jz - 1] -= i << (24 - q0);
      ih = iq[jz - 1] >> (23 - q0);
    } else if (q0 === 0) {
      ih = iq[jz - 1] >> 23;
    } else if (z >= 0.5) {
      ih = 2;
    }
    if (ih > 0) {
      n += 1;
      let carry = false;
      for (let i = 0; i < jz; i++) {
        if (carry) {
          iq[i] = 0xffffff - iq[i];
        } else if (iq[i] !== 0) {
          carry = true;
          iq[i] = TWO24 - iq[i];
        }
      }
      if (q0 === 1) iq[jz - 1] &= 0x7fffff;
      if (q0 === 2) iq[jz - 1] &= 0x3fffff;
      if (ih === 2) {
        z = 1 - z;
        if (carry) z = z - powerOf2(q0);
      }
    }
    if (z !== 0 || iq.slice(jk, jz).some((digit) => digit !== 0)) break;
    let k = 1;
    while (iq[jk - k] === 0) k++;
    for (let i = jz + 1; i <= jz + k; i++) {
      f[jx + i] = TWO_OVER_PI[jv + i];
      q[i] = sum(i);
    }
    jz += k;
  }

  if (z === 0) {
    do {
      jz -= 1;
      q0 -= 24;
    } while (iq[jz] === 0);
  } else {
    z = z * powerOf2(-q0);
    if (z >= TWO24) {
      const fw = Math.trunc(z / TWO24);
      iq[jz] = z - fw * TWO24;
      jz += 1;
      q0 += 24;
      iq[jz] = fw;
    } else {
      iq[jz] = z;
    }
  }
  for (let i = jz; i >= 0; i--) q[i] = iq[i] * powerOf2(q0 - 24 * (jz - i));
  /** @type {number[]} */
  const fq = [];
  for (let i = jz; i >= 0; i--) {
    let fw = 0;
    for (let k = 0; k <= Math.min(4, jz - i); k++) {
      fw += PIO2_PIECES[k] * q[i + k];
    }
    fq[jz - i] = fw;
  }
  let y0 = 0;
  for (let i = jz; i >= 0; i--) y0 += fq[i];
  let y1 = fq[0] - y0;
  for (let i = 1; i <= jz; i++) y1 += fq[i];
  if ((ih !== 0) !== negative) {
    y0 = -y0;
    y1 = -y1;
  }
  reduced.n = negative ? -n : n;
  reduced.y0 = y0;
  reduced.y1 = y1;
  reduced.itself = false;
  return reduced;
}

const S1 = double(0xbfc55555, 0x55555549);
const S2 = double(0x3f811111, 0x1110f8a6);
const S3 = double(0xbf2a01a0, 0x19c161d5);
const S4 = double(0x3ec71de3, 0x57b1fe7d);
const S5 = double(0xbe5ae5e6, 0x8a2b9ceb);
const S6 = double(0x3de5d93a, 0x5acfd57c);
const C1 = double(0x3fa55555, 0x5555554c);
const C2 = double(0xbf56c16c, 0x16c15177);
const C3 = double(0x3efa01a0, 0x19cb1590);
const C4 = double(0xbe927e4f, 0x809c52ad);
const C5 = double(0x3e21ee9e, 0xbdb4b1c4);
const C6 = double(0xbda8fae9, 0xbe8838d4);

// [snippet: portable-sin]
/**
 * The sine (fdlibm's).
 *
 * @param {number} x an angle in radians, any double
 * @returns {number} sin(x); NaN for infinities and NaN
 */
export function sin(x) {
  const { n, y0, y1, itself } = remPio2(x);
  const odd = (n & 1) !== 0;
  const value = odd ? kernelCos(y0, y1) : kernelSin(y0, y1, !itself);
  return (n & 2) !== 0 ? -value : value;
}

/**
 * The cosine (fdlibm's).
 *
 * @param {number} x an angle in radians, any double
 * @returns {number} cos(x); NaN for infinities and NaN
 */
export function cos(x) {
  const { n, y0, y1 } = remPio2(x);
  const odd = (n & 1) !== 0;
  const value = odd ? kernelSin(y0, y1, true) : kernelCos(y0, y1);
  return ((n + 1) & 2) !== 0 ? -value : value;
}

/** sin(x + y) for |x| up to pi/4; y is 0 where x is not reduced. */
function kernelSin(
  /** @type {number} */ x,
  /** @type {number} */ y,
  /** @type {boolean} */ isReduced,
) {
  const ix = highWord(x) & 0x7fffffff;
  if (ix < 0x3e400000) return x; // |x| < 2^-27
  const z = x * x;
  const v = z * x;
  const r = S2 + z * (S3 + z * (S4 + z * (S5 + z * S6)));
  return isReduced
    ? x - (z * (0.5 * y - v * r) - y - v * S1)
    : x + v * (S1 + z * r);
}

/** cos(x + y) for |x| up to pi/4. */
function kernelCos(/** @type {number} */ x, /** @type {number} */ y) {
  const ix = highWord(x) & 0x7fffffff;
  if (ix < 0x3e400000) return 1;
  const z = x * x;
  const r = z * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * C6)))));
  if (ix < 0x3fd33333) return 1 - (0.5 * z - (z * r - x * y)); // |x| < 0.3
  // about x/4 with few bits, so that 1 - qx is exact
  const qx = ix > 0x3fe90000 ? 0.28125 : double(ix - 0x00200000, 0);
  const hz = 0.5 * z - qx;
  const a = 1 - qx;
  return a - (hz - (z * r - x * y));
}
// [/snippet]

const LN2_HIGH = double(0x3fe62e42, 0xfee00000);
const LN2_LOW = double(0x3dea39ef, 0x35793c76);
const INV_LN2 = double(0x3ff71547, 0x652b82fe);
const EXP_MOST = double(0x40862e42, 0xfefa39ef);
const EXP_LEAST = double(0xc0874910, 0xd52d3051);
const P1 = double(0x3fc55555, 0x5555553e);
const P2 = double(0xbf66c16c, 0x16bebd93);
const P3 = double(0x3f11566a, 0xaf25de2c);
const P4 = double(0xbebbbd41, 0xc5d26bf1);
const P5 = double(0x3e663769, 0x72bea4d0);

// [snippet: portable-exp]
/**
 * The exponential function (fdlibm's).
 *
 * @param {number} x any double
 * @returns {number} e to the power of x
 */
export function exp(x) {
  if (!(x <= EXP_MOST)) return x > EXP_MOST ? Infinity : x;
  if (x < EXP_LEAST) return 0;
  const ix = highWord(x) & 0x7fffffff;
  let k = 0;
  let high = 0;
  let low = 0;
  if (ix > 0x3fd62e42) {
    // |x| > 0.5 ln 2: x = k ln 2 + high - low
    const half = x < 0 ? -0.5 : 0.5;
    k = ix < 0x3ff0a2b2 ? 2 * half : Math.trunc(INV_LN2 * x + half);
    high = x - k * LN2_HIGH;
    low = k * LN2_LOW;
    x = high - low;
  } else if (ix < 0x3e300000) {
    return 1 + x;
  }
  const t = x * x;
  const c = x - t * (P1 + t * (P2 + t * (P3 + t * (P4 + t * P5))));
  if (k === 0) return 1 - ((x * c) / (c - 2) - x);
  const y = 1 - (low - (x * c) / (2 - c) - high);
  // times 2^k, in two steps where the result is subnormal
  if (k >= -1021) return withHighWord(y, highWord(y) + (k << 20));
  return withHighWord(y, highWord(y) + ((k + 1000) << 20)) * TWO_M1000;
}
// [/snippet]

const LG1 = double(0x3fe55555, 0x55555593);
const LG2 = double(0x3fd99999, 0x9997fa04);
const LG3 = double(0x3fd24924, 0x94229359);
const LG4 = double(0x3fcc71c5, 0x1d8e78af);
const LG5 = double(0x3fc74664, 0x96cb03de);
const LG6 = double(0x3fc39a09, 0xd078c69f);
const LG7 = double(0x3fc2f112, 0xdf3e5244);
const THIRD = double(0x3fd55555, 0x55555555);

// [snippet: portable-log]
/**
 * The natural logarithm (fdlibm's).
 *
 * @param {number} x any double
 * @returns {number} log(x); minus infinity for zeros, NaN below zero
 */
export function log(x) {
  if (!(x > 0 && x < Infinity)) {
    return x === 0 ? -Infinity : x > 0 ? x : NaN;
  }
  // x = 2^k (1 + f)
  const subnormal = x < LEAST_NORMAL;
  if (subnormal) x *= TWO54;
  const top = highWord(x);
  const hx = top & 0xfffff;
  const i = (hx + 0x95f64) & 0x100000;
  const f = withHighWord(x, hx | (i ^ 0x3ff00000)) - 1;
  const k = (subnormal ? -54 : 0) + (top >> 20) - 1023 + (i >> 20);
  if ((0xfffff & (2 + hx)) < 3) {
    // |f| < 2^-20
    if (f === 0) return k === 0 ? 0 : k * LN2_HIGH + k * LN2_LOW;
    const r = f * f * (0.5 - THIRD * f);
    return k === 0 ? f - r : k * LN2_HIGH - (r - k * LN2_LOW - f);
  }
  const s = f / (2 + f);
  const z = s * s;
  const w = z * z;
  const t1 = w * (LG2 + w * (LG4 + w * LG6));
  const t2 = z * (LG1 + w * (LG3 + w * (LG5 + w * LG7)));
  const r = t2 + t1;
  if (((hx - 0x6147a) | (0x6b851 - hx)) > 0) {
    const half = 0.5 * f * f;
    return k === 0
      ? f - (half - s * (half + r))
      : k * LN2_HIGH - (half - (s * (half + r) + k * LN2_LOW) - f);
  }
  return k === 0
    ? f - s * (f - r)
    : k * LN2_HIGH - (s * (f - r) - k * LN2_LOW - f);
}
// [/snippet]
