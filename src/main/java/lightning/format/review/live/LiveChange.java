package lightning.format.review.live;

import java.util.List;
import lightning.format.review.Review;

/**
 * Change of a reviewer in a live page.
 *
 * @param page     random name of the page, to distinguish reviewers
 * @param reviewer name that the reviewer entered; may be empty
 * @param state    changed values
 * @param notes    all notes of the page
 */
public record LiveChange(String page, String reviewer, LiveState state, List<Review.Note> notes) {}
