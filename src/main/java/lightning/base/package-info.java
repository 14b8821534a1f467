/**
 * Annotation for the check of null values.
 * Utilities for any program; nothing here depends on scenes or pictures.
 */
@NullMarked
package lightning.base;

import org.jspecify.annotations.NullMarked;
