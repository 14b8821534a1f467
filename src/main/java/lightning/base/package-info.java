/** Annotation for the check of null values. */
@NullMarked
package lightning.base;

import org.jspecify.annotations.NullMarked;
