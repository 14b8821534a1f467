/** Output of commands: messages, progress, tables, reports, pictures and the exit code. */
package lightning.cli.output;
