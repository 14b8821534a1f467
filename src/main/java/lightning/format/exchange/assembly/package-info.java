/** Parts that all importers share: files to copy, names, units, bounds, and the assembled scene. */
package lightning.format.exchange.assembly;
