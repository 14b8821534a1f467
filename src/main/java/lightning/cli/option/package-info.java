/** Options that several commands share, and their converters. */
@NullMarked
package lightning.cli.option;

import org.jspecify.annotations.NullMarked;
