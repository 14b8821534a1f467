package lightning.shot;

/**
 * How much is kept of a shot.
 *
 * @param memoryFrames frames in memory
 * @param memoryBytes   bytes of these
 * @param diskFrames   frames on disk
 * @param diskBytes     bytes of these
 */
public record CacheUsage(int memoryFrames, long memoryBytes, int diskFrames, long diskBytes) {
    public static final CacheUsage NONE = new CacheUsage(0, 0, 0, 0);

    public CacheUsage plus(CacheUsage o) {
        return new CacheUsage(memoryFrames + o.memoryFrames, memoryBytes + o.memoryBytes, diskFrames + o.diskFrames,
                diskBytes + o.diskBytes);
    }
}
