package lightning.cli.report;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Written review page, or applied review.
 *
 * @param output   the written page or scene; absent if a review was only read
 * @param bytes    size of the page; absent for a review
 * @param lights   lights with a fader on the page, or changed by the review
 * @param reviewer name of the reviewer; absent for a page
 * @param comments notes of the reviewer; empty for a page
 */
public record ReviewReport(@Nullable String output, @Nullable Long bytes, List<String> lights, @Nullable String reviewer,
        List<Comment> comments) {
    /**
     * Note at a place of the picture.
     *
     * @param x pixels from the left
     * @param y pixels from the top
     */
    public record Comment(int x, int y, String text) {}
}
