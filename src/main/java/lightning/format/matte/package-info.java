/** Cryptomatte: mattes of objects and materials as ranked ids and coverages (Cryptomatte Specification 1.2, Psyop). */
@NullMarked
package lightning.format.matte;

import org.jspecify.annotations.NullMarked;
