/** Results of a benchmark run, as records and as a CSV file. */
@NullMarked
package lightning.bench.result;

import org.jspecify.annotations.NullMarked;
