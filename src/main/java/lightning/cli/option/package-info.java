/** Options that several commands share, and their converters. */
package lightning.cli.option;
