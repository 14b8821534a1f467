/** Panel of live reviews: reviewers at other screens see the picture and its lights while the artist works. */
@NullMarked
package lightning.editor.window.review;

import org.jspecify.annotations.NullMarked;
