/** Live reviews: a page in a browser that follows a scene while it is edited, and may edit its lights. */
@NullMarked
package lightning.review.live;

import org.jspecify.annotations.NullMarked;
