/** Start of the program. */
@NullMarked
package lightning;

import org.jspecify.annotations.NullMarked;
