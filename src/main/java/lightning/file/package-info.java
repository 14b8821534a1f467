/**
 * Writing files so that an interrupted save loses nothing.
 *
 * <pre>{@code
 * SafeFile.write(path, out -> out.write(bytes));
 * }</pre>
 */
package lightning.file;
