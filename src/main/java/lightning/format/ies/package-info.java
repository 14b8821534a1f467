/** IES photometric profiles (ANSI/IES LM-63), with their content validated. */
package lightning.format.ies;
