/**
 * Words that people and files write: numbers, what is found quoted in a message, characters that a line can show.
 *
 * <pre>{@code
 * OptionalDouble number = DecimalNumber.parse(word);
 * throw new IOException(Quote.path(file) + ": expected a number, found " + Quote.of(word));
 * }</pre>
 */
package lightning.base.text;
