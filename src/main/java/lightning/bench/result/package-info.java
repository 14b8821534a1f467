/** Results of a benchmark run, as records and as a CSV file. */
package lightning.bench.result;
