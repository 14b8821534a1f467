package lightning.render.gather.cell;

/** Hash of 64 bits: the finalizer of MurmurHash3 (Austin Appleby, public domain). */
public final class Hash64 {
    private Hash64() {}

    public static long mix(long x) {
        long h = x;
        h ^= h >>> 33;
        h *= 0xff51afd7ed558ccdL;
        h ^= h >>> 33;
        h *= 0xc4ceb9fe1a85ec53L;
        return h ^ h >>> 33;
    }
}
