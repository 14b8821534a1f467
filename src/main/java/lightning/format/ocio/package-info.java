/** OpenColorIO configurations, read by a converter in Python, and their views as tables. */
@NullMarked
package lightning.format.ocio;

import org.jspecify.annotations.NullMarked;
