package lightning.format.review.live;

import java.util.List;
import lightning.format.review.Review;

/**
 * What a reviewer did in a live page.
 *
 * @param page     random name of the page, which tells reviewers apart
 * @param reviewer name that the reviewer entered; may be empty
 * @param state    changed values
 * @param notes    all notes of the page
 */
public record LiveChange(String page, String reviewer, LiveState state, List<Review.Note> notes) {}
