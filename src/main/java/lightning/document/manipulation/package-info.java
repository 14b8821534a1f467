/** Handles and picking in the preview: from a pointer to a place in the scene. */
@NullMarked
package lightning.document.manipulation;

import org.jspecify.annotations.NullMarked;
