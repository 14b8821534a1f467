/** IES photometric profiles (ANSI/IES LM-63), with their content validated. */
@NullMarked
package lightning.format.ies;

import org.jspecify.annotations.NullMarked;
