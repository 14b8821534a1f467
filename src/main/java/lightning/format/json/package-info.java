/** JSON objects of the command line and the server, in the form of docs/json.md. */
@NullMarked
package lightning.format.json;

import org.jspecify.annotations.NullMarked;
