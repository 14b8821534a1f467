/** Files of luminous intensities by direction, ANSI/IES LM-63, held to what they have. */
package lightning.format.ies;
