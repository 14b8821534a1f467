/**
 * JSON objects of the command line and the server, in the form of docs/json.md, and checked values of JSON that others wrote.
 * Reports of single commands belong to {@code cli.report}.
 */
@NullMarked
package lightning.format.json;

import org.jspecify.annotations.NullMarked;
