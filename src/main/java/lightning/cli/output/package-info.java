/** What commands write: messages, progress, tables, reports, pictures and the exit code. */
package lightning.cli.output;
