package lightning.shot;

/**
 * How much is kept of a shot.
 *
 * @param inMemory frames in memory
 * @param memory   bytes of these
 * @param onDisk   frames on disk
 * @param disk     bytes of these
 */
public record KeptBytes(int inMemory, long memory, int onDisk, long disk) {
    public static final KeptBytes NONE = new KeptBytes(0, 0, 0, 0);

    public KeptBytes plus(KeptBytes o) {
        return new KeptBytes(inMemory + o.inMemory, memory + o.memory, onDisk + o.onDisk, disk + o.disk);
    }
}
