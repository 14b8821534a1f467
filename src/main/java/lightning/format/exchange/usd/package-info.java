/** Import of USD: materials, lights, shapes and their tracks. */
package lightning.format.exchange.usd;
