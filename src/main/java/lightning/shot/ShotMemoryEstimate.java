package lightning.shot;

import java.util.Locale;
import java.util.stream.IntStream;
import lightning.render.RenderOptions;
import lightning.render.relight.MemoryEstimate;
import lightning.render.trace.MeshMemory;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;

/**
 * Estimated memory for the frames of a shot, before any is traced.
 *
 * @param frameCount    number of frames
 * @param bytesPerFrame approximate bytes of a frame
 * @param meshBytes     bytes shared by all frames
 * @param picture       image settings of each frame
 */
public record ShotMemoryEstimate(int frameCount, long bytesPerFrame, long meshBytes, PictureSettings picture) {
    /** Number of frames rendered as small images. */
    private static final int SAMPLED_FRAMES = 3;
    /** Frames in progress in two lanes, each with its old cache. */
    private static final int ACTIVE_FRAMES = 4;
    private static final double GB = 1e9;

    /**
     * Estimates the frames from {@code first} to {@code last} by the largest of a few samples.
     *
     * @throws IllegalArgumentException as {@link ShotRevision#sceneAt}
     */
    public static ShotMemoryEstimate of(ShotRevision revision, int first, int last, RenderOptions options) {
        long bytesPerFrame =
                IntStream.range(0, SAMPLED_FRAMES).map(i -> first + (int) ((long) (last - first) * i / (SAMPLED_FRAMES - 1))).distinct()
                        .mapToLong(frame -> MemoryEstimate.forecast(revision.sceneAt(frame), options)).max().orElseThrow();
        Scene scene = revision.scene();
        return new ShotMemoryEstimate(last - first + 1, bytesPerFrame, MeshMemory.bytes(scene), scene.picture());
    }

    /** Returns the bytes of all frames. */
    public long totalBytes() {
        return frameCount * bytesPerFrame;
    }

    /**
     * Returns the bytes in memory for frames not in progress.
     *
     * @param memory bytes for images in this JVM
     */
    public long frameBudget(long memory) {
        return Math.max(0, memory - meshBytes - ACTIVE_FRAMES * bytesPerFrame);
    }

    /**
     * Checks that the shot fits.
     *
     * @param memory bytes in memory for frames not in progress
     * @param disk   bytes on disk
     * @throws ShotTooLargeException if it needs more than both; the message says what would fit
     */
    public void check(long memory, long disk) {
        long available = memory + disk;
        if (totalBytes() <= available) {
            return;
        }
        long fittingFrames = available / Math.max(1, bytesPerFrame);
        double scale = Math.sqrt((double) available / totalBytes()) * 0.95;
        int width = (int) (picture.width() * scale);
        int height = (int) (picture.height() * scale);
        throw new ShotTooLargeException(String.format(Locale.ROOT,
                "%d frames of about %s need %s, but only %s of memory and %s of disk space are free; %s",
                frameCount, formatBytes(bytesPerFrame), formatBytes(totalBytes()), formatBytes(memory), formatBytes(disk),
                Math.min(width, height) < 1 ? "no frame would fit"
                        : (fittingFrames == 0 ? "" : fittingFrames == 1 ? "one frame would fit, or "
                                : fittingFrames + " frames would fit, or ")
                                + "a size of " + width + "x" + height + (fittingFrames > 0 ? "" : " would fit")));
    }

    /** Formats bytes for the user. */
    public static String formatBytes(long bytes) {
        return bytes < GB / 10 ? String.format(Locale.ROOT, "%.1f MB", bytes / 1e6) : String.format(Locale.ROOT, "%.1f GB", bytes / GB);
    }
}
