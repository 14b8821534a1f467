/**
 * Text handling: numbers, quoting in messages, printable characters and translations.
 *
 * <pre>{@code
 * OptionalDouble number = DecimalNumber.parse(word);
 * throw new IOException(Quote.path(file) + ": expected a number, found " + Quote.of(word));
 * }</pre>
 */
@NullMarked
package lightning.base.text;

import org.jspecify.annotations.NullMarked;
