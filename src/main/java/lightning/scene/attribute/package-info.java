/**
 * Descriptors of attributes: name, kind of value, range, comparison and format.
 * The attributes themselves stand beside the records that have them.
 */
@NullMarked
package lightning.scene.attribute;

import org.jspecify.annotations.NullMarked;
