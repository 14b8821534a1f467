/** Descriptors of attributes: name, kind of value, range, comparison and format. */
@NullMarked
package lightning.scene.attribute;

import org.jspecify.annotations.NullMarked;
