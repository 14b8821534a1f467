package lightning.cli.report;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Written review page, or applied review.
 *
 * @param output   the written page or scene; absent if a review was only read
 * @param bytes    size of the page; absent for a review
 * @param lights   lights with a fader on the page, or changed by the review
 * @param frames   frames on the page; empty for a still picture and for a review
 * @param looks    looks on the page; empty for a review
 * @param reviewer name of the reviewer; absent for a page
 * @param comments notes of the reviewer; empty for a page
 */
public record ReviewReport(@Nullable String output, @Nullable Long bytes, List<String> lights, List<Integer> frames,
        List<String> looks, @Nullable String reviewer,
        List<Comment> comments) {
    /**
     * Note at a place of a picture.
     *
     * @param frame frame of the picture; absent for a still picture
     * @param x pixels from the left
     * @param y pixels from the top
     */
    public record Comment(@Nullable Integer frame, int x, int y, String text) {}
}
