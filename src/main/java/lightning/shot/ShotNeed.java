package lightning.shot;

import java.util.Locale;
import java.util.stream.IntStream;
import lightning.render.relight.MemoryNeed;
import lightning.render.relight.tile.Options;
import lightning.render.trace.MeshMemory;
import lightning.scene.Picture;
import lightning.scene.Scene;

/**
 * How much it takes to keep the frames of a shot, before any of them is traced.
 *
 * @param frames  how many
 * @param each    about the bytes of a frame
 * @param meshes  bytes of what all share
 * @param picture of each
 */
public record ShotNeed(int frames, long each, long meshes, Picture picture) {
    /** Frames of which small pictures are made. */
    private static final int LOOKED_AT = 3;
    /** Frames that two lanes work on, each beside what was known of it. */
    private static final int UNDER_WAY = 4;
    private static final double GB = 1e9;

    /**
     * What the frames from {@code first} to {@code last} take, by the largest of some of them.
     *
     * @throws IllegalArgumentException as {@link Take#at}
     */
    public static ShotNeed of(Take take, int first, int last, Options options) {
        long each = IntStream.range(0, LOOKED_AT).map(i -> first + (int) ((long) (last - first) * i / (LOOKED_AT - 1))).distinct()
                .mapToLong(frame -> MemoryNeed.forecast(take.at(frame), options)).max().orElseThrow();
        Scene scene = take.scene();
        return new ShotNeed(last - first + 1, each, MeshMemory.bytes(scene), scene.picture());
    }

    /** The bytes of all frames. */
    public long all() {
        return frames * each;
    }

    /**
     * The bytes that frames which nobody works on may take in memory.
     *
     * @param memory bytes that pictures may take in this Java
     */
    public long inMemory(long memory) {
        return Math.max(0, memory - meshes - UNDER_WAY * each);
    }

    /**
     * Refuses a shot that does not fit.
     *
     * @param memory bytes that resting frames may take in memory, likewise {@code disk}
     * @throws ShotTooLarge if it takes more than both; the message says what would fit
     */
    public void check(long memory, long disk) {
        long room = memory + disk;
        if (all() <= room) {
            return;
        }
        long fitting = room / Math.max(1, each);
        double shrink = Math.sqrt((double) room / all()) * 0.95;
        int width = (int) (picture.width() * shrink);
        int height = (int) (picture.height() * shrink);
        throw new ShotTooLarge(String.format(Locale.ROOT,
                "%d frames of about %s take %s, and there is room for %s in memory and for %s on disk; %s",
                frames, text(each), text(all()), text(memory), text(disk),
                Math.min(width, height) < 1 ? "nothing would fit"
                        : (fitting == 0 ? "" : fitting == 1 ? "one frame would fit, or " : fitting + " frames would fit, or ")
                                + "a size of " + width + "x" + height + (fitting > 0 ? "" : " would fit")));
    }

    /** Bytes, for people. */
    public static String text(long bytes) {
        return bytes < GB / 10 ? String.format(Locale.ROOT, "%.1f MB", bytes / 1e6) : String.format(Locale.ROOT, "%.1f GB", bytes / GB);
    }
}
