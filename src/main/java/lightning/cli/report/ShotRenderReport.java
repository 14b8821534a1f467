package lightning.cli.report;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Rendered frames of a shot.
 *
 * @param file    video; absent if frames are images
 * @param skipped frames that existed, with {@code --resume}
 */
public record ShotRenderReport(@Nullable String file, double framesPerSecond, int skipped, int traced, double tracedMilliseconds, int relit,
        double relitMilliseconds, List<Frame> frames) {
    /**
     * A frame.
     *
     * @param image absent in a video
     */
    public record Frame(int frame, @Nullable String image, String plan, double milliseconds) {}
}
