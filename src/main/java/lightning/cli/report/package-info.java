/**
 * Reports of commands with {@code --json}: one record for each command, in the form of docs/json.md. Names of numbers end in their unit;
 * counts, and values without a unit, have none. {@link lightning.cli.report.JsonOutput} prints them.
 */
@NullMarked
package lightning.cli.report;

import org.jspecify.annotations.NullMarked;
