/**
 * Annotation for the check of null values.
 * What any program could use; nothing here knows scenes or pictures.
 */
@NullMarked
package lightning.base;

import org.jspecify.annotations.NullMarked;
