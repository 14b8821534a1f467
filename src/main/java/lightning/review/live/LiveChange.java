package lightning.review.live;

import java.util.List;
import java.util.Optional;
import java.util.SequencedMap;
import lightning.review.Review;

/**
 * Change of a reviewer in a live page.
 *
 * @param page     random name of the page, to distinguish reviewers
 * @param reviewer name that the reviewer entered; may be empty
 * @param state    changed values
 * @param notes    all notes of the page
 */
public record LiveChange(String page, String reviewer, LiveState state, List<Review.Note> notes) {
    /** Puts the newest notes of its page in place of earlier ones, at the end. Pages without notes are not stored, so that the map stays small. */
    public void storeNotes(SequencedMap<String, LiveChange> byPage) {
        byPage.remove(page);
        if (!notes.isEmpty()) {
            byPage.put(page, new LiveChange(page, reviewer, new LiveState(List.of(), List.of(), Optional.empty()), notes));
        }
    }
}
