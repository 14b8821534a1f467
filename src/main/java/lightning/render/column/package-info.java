/**
 * Columns of rows: plain arrays that share one index. Rows of each kind tell in one closed set which columns they may have;
 * how these are made, counted and shared follows from that.
 */
package lightning.render.column;
