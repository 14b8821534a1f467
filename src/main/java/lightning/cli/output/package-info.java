/** Output of commands: messages, progress, tables, reports, pictures and the exit code. */
@NullMarked
package lightning.cli.output;

import org.jspecify.annotations.NullMarked;
