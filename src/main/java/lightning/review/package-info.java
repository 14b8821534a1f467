/**
 * Review pages: a picture with a fader for each light in one HTML file, and the files that reviewers save in it.
 * Applying what reviewers saved is an edit of {@code document}.
 */
@NullMarked
package lightning.review;

import org.jspecify.annotations.NullMarked;
