package lightning.shot;

/**
 * Cache usage of a shot.
 *
 * @param memoryFrames frames in memory
 * @param memoryBytes  bytes of the frames in memory
 * @param diskFrames   frames on disk
 * @param diskBytes    bytes of the frames on disk
 */
public record CacheUsage(int memoryFrames, long memoryBytes, int diskFrames, long diskBytes) {
    public static final CacheUsage NONE = new CacheUsage(0, 0, 0, 0);

    public CacheUsage plus(CacheUsage o) {
        return new CacheUsage(memoryFrames + o.memoryFrames, memoryBytes + o.memoryBytes, diskFrames + o.diskFrames,
                diskBytes + o.diskBytes);
    }
}
